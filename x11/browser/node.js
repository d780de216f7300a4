// Under Node the program is a command: the folders of the machine are its own, and what it prints goes out at once.
if (typeof process === 'object' && typeof document === 'undefined') {
  const fs = require('fs'), streams = {1: [], 2: []};
  const flush = to => { if (streams[to].length) fs.writeSync(to, Buffer.from(streams[to])); streams[to] = []; };
  const put = to => byte => { if (byte !== null && streams[to].push(byte) > 65535) flush(to); };
  Module.preRun = [() => {
    FS.init(() => null, put(1), put(2));
    for (const name of fs.readdirSync('/'))
      if (!['dev', 'proc', 'usr'].includes(name) && fs.statSync('/' + name).isDirectory()) {
        if (!FS.analyzePath('/' + name).exists) FS.mkdir('/' + name);
        FS.mount(NODEFS, {root: '/' + name}, '/' + name);
      }
    FS.chdir(process.cwd());
  }];
  Module.onRuntimeInitialized = () => {
    process.exitCode = Module.callMain(process.argv.slice(2));
    flush(1), flush(2);
  };
}
