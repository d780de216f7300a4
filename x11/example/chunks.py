"""Which chunks of two PNG files have the same bytes: python3 chunks.py a.png b.png"""
import sys
def chunks(name, at=8):
    data, found = open(name, "rb").read(), {}
    while at < len(data):
        end = at + 12 + int.from_bytes(data[at:at + 4], "big")
        found[data[at + 4:at + 8].decode()], at = data[at + 8:end - 4], end
    return found
a, b = map(chunks, sys.argv[1:])
print({name: a[name] == b[name] for name in a})
