/** limber completion bash|zsh|fish: a script that completes commands, flags and their words, made from the table of flags. */

import { EXIT, UsageError } from '../failure';
import type { Flag } from '../flag';
import { COMMAND_SPECS, COMMANDS, flagsOf } from '../flags';
import type { Command } from '../flags';

const SHELLS = { bash: bashScript, zsh: zshScript, fish: fishScript } as const;
export type Shell = keyof typeof SHELLS;
const SHELL_NAMES = Object.keys(SHELLS) as Shell[];

const HELP = `limber completion ${SHELL_NAMES.join('|')}
Print a script that completes commands, flags and the values of flags.

  bash   eval "$(limber completion bash)" in ~/.bashrc
  zsh    limber completion zsh > a file _limber in a folder of $fpath
  fish   limber completion fish > ~/.config/fish/completions/limber.fish
`;

/** Writes the script, or its help, to stdout. Throws UsageError. */
export function runCompletion(words: string[]): number {
  if (words.some((word) => word === '--help' || word === '-h')) {
    process.stdout.write(HELP);
    return EXIT.done;
  }
  const shell = SHELL_NAMES.find((name) => name === words[0]);
  if (!shell || words.length > 1)
    throw new UsageError(`limber completion takes one of ${SHELL_NAMES.join(', ')}.`);
  process.stdout.write(completionScript(shell));
  return EXIT.done;
}

export const completionScript = (shell: Shell): string => SHELLS[shell]();

/** The words that a flag takes; none where it takes a number, name or file. */
export function wordsOf({ value = '' }: Flag): string[] {
  const words = value.split('|');
  return words.length > 1 && words.every((word) => /^[a-z][a-z0-9.-]*$/.test(word)) ? words : [];
}

const takesFile = ({ value = '' }: Flag): boolean => /FILE|OUT/.test(value);
const others = ['completion', 'help', 'version'];
/** Flags that stand in place of a command, without their dashes. */
const QUESTIONS = ['help', 'version'];
/** What limber help is asked about. */
const HELPED = [...COMMANDS, 'completion'];
const quoted = (text: string): string => `'${text.replaceAll("'", "'\\''")}'`;

function bashScript(): string {
  const flags = (command: Command) =>
    `    ${command}) flags=${quoted(
      flagsOf(command)
        .map(({ name }) => `--${name}`)
        .join(' '),
    )} ;;`;
  const words = new Map(COMMANDS.flatMap(flagsOf).map((flag) => [flag.name, wordsOf(flag)]));
  const choices = [...words].filter(([, own]) => own.length > 0);
  return `# bash completion of limber: eval "$(limber completion bash)"
_limber() {
  local current=\${COMP_WORDS[COMP_CWORD]} previous=\${COMP_WORDS[COMP_CWORD-1]} flags=
  if [ "$COMP_CWORD" -eq 1 ]; then
    case $current in
      -*) COMPREPLY=($(compgen -W ${quoted(QUESTIONS.map((name) => `--${name}`).join(' '))} -- "$current")) ;;
      *) COMPREPLY=($(compgen -W ${quoted([...COMMANDS, ...others].join(' '))} -- "$current")) ;;
    esac
    return
  fi
  case $previous in
    completion) COMPREPLY=($(compgen -W ${quoted([...SHELL_NAMES, '--help'].join(' '))} -- "$current")); return ;;
    help) COMPREPLY=($(compgen -W ${quoted(HELPED.join(' '))} -- "$current")); return ;;
${choices.map(([name, own]) => `    --${name}) COMPREPLY=($(compgen -W ${quoted(own.join(' '))} -- "$current")); return ;;`).join('\n')}
  esac
  case \${COMP_WORDS[1]} in
${COMMANDS.map(flags).join('\n')}
  esac
  case $current in
    -*) COMPREPLY=($(compgen -W "$flags" -- "$current")) ;;
    *) COMPREPLY=() ;;
  esac
}
complete -o default -F _limber limber
`;
}

/** What _arguments takes for a flag; brackets and colons of texts are escaped. */
function zshFlag(flag: Flag): string {
  const { name, value, help } = flag;
  const text = help.replace(/[[\]\\]/g, '\\$&').replaceAll(':', '\\:');
  const words = wordsOf(flag);
  const action = words.length > 0 ? `(${words.join(' ')})` : takesFile(flag) ? '_files' : '';
  const shown = (value ?? '').replace(/[[\]\\:]/g, '\\$&');
  return quoted(
    `--${name}${value === undefined ? '' : '='}[${text}]${value === undefined ? '' : `:${shown}:${action}`}`,
  );
}

function zshScript(): string {
  const commands = COMMANDS.map((command) =>
    quoted(`${command}:${COMMAND_SPECS[command].summary.replaceAll(':', '\\:')}`),
  );
  const cases = COMMANDS.map(
    (command) =>
      `    ${command}) _arguments ${flagsOf(command).map(zshFlag).join(' \\\n      ')} '*:file:_files' ;;`,
  );
  return `#compdef limber
# zsh completion of limber: limber completion zsh > a file _limber in a folder of $fpath
_limber() {
  local -a commands=(${commands.join(' ')} ${others.map((name) => quoted(name)).join(' ')})
  if (( CURRENT == 2 )); then
    _describe command commands
    compadd -- ${QUESTIONS.map((name) => `--${name}`).join(' ')}
    return
  fi
  local command=$words[2]
  shift words
  (( CURRENT-- ))
  case $command in
    completion) _values shell ${SHELL_NAMES.join(' ')} ;;
    help) compadd -- ${HELPED.join(' ')} ;;
${cases.join('\n')}
  esac
}
if [ "$funcstack[1]" = "_limber" ]; then _limber "$@"; else compdef _limber limber; fi
`;
}

const fishText = (text: string): string => `'${text.replace(/[\\']/g, '\\$&')}'`;

function fishScript(): string {
  const isFirst = `-n ${fishText('__fish_use_subcommand')}`;
  const commands = COMMANDS.map(
    (command) =>
      `complete -c limber -f ${isFirst} -a ${command} -d ${fishText(COMMAND_SPECS[command].summary)}`,
  );
  const flags = COMMANDS.flatMap((command) =>
    flagsOf(command).map((flag) => {
      const words = wordsOf(flag);
      const value =
        words.length > 0 ? ` -x -a ${fishText(words.join(' '))}` : takesFile(flag) ? ' -r -F' : ' -x';
      const only = `-n ${fishText(`__fish_seen_subcommand_from ${command}`)}`;
      return `complete -c limber ${only} -l ${flag.name}${flag.value === undefined ? '' : value} -d ${fishText(flag.help)}`;
    }),
  );
  return `# fish completion of limber: limber completion fish > ~/.config/fish/completions/limber.fish
${[...commands, ...others.map((name) => `complete -c limber -f ${isFirst} -a ${name}`)].join('\n')}
${QUESTIONS.map((name) => `complete -c limber -f ${isFirst} -l ${name}`).join('\n')}
complete -c limber -x -n '__fish_seen_subcommand_from completion' -a ${fishText(SHELL_NAMES.join(' '))}
complete -c limber -x -n '__fish_seen_subcommand_from help' -a ${fishText(HELPED.join(' '))}
${flags.join('\n')}
`;
}
