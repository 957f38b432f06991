# bash completion for weir

_weir() {
  local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} command=${COMP_WORDS[1]}
  COMPREPLY=()
  if ((COMP_CWORD == 1)); then
    mapfile -t COMPREPLY < <(compgen -W "run check batch compare report info schema -h --help --version" -- "$word")
    return
  fi
  case $previous in
    --progress) mapfile -t COMPREPLY < <(compgen -W "auto bar lines json none" -- "$word"); return ;;
    --instruction-set) mapfile -t COMPREPLY < <(compgen -W "baseline avx2 avx512" -- "$word"); return ;;
    --gl-device) mapfile -t COMPREPLY < <(compgen -W "auto software" -- "$word"); return ;;
    -o | --output) mapfile -t COMPREPLY < <(compgen -d -- "$word"); return ;;
    --difference) mapfile -t COMPREPLY < <(compgen -f -- "$word"); return ;;
    --set | --threads | --max-wall-time | -j | --jobs | --tolerance | --fraction) return ;;
  esac
  local options
  case $command in
    run) options="-h --help -o --output --set --threads --force --progress --max-wall-time --gl-device --instruction-set --trace" ;;
    check) options="-h --help --set --threads --print" ;;
    batch) options="-h --help -o --output -j --jobs --set --threads --force --gl-device" ;;
    compare) options="-h --help --tolerance --fraction --difference --json" ;;
    report) options="-h --help -o --output --threads --gl-device" ;;
    info) options="-h --help --json" ;;
    *) options="-h --help" ;;
  esac
  if [[ $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word")
  elif [[ $command == report ]]; then
    mapfile -t COMPREPLY < <(compgen -W "hinsch2024 speed" -- "$word")
  elif [[ $command == run || $command == check || $command == batch ]]; then
    mapfile -t COMPREPLY < <(compgen -f -X '!*.yaml' -- "$word"; compgen -d -S / -- "$word")
  else
    mapfile -t COMPREPLY < <(compgen -f -- "$word")
  fi
}
complete -o filenames -F _weir weir
