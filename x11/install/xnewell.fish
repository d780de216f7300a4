# Completes the words after xnewell in fish: the program proposes them.
function __xnewell
    set -l words (commandline -opc)
    set -l now (commandline -ct)
    $words[1] complete -- $words[2..-1] "$now" 2>/dev/null
end
complete -c xnewell -f -a '(__xnewell)'
