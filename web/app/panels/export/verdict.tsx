/** What the Khronos validator finds in the result, and how much of it was already in the input. */

import { knownMessages } from '../../../engine/document/facts/known_messages';
import type { Validation } from '../../../engine/document/validate';
import type { ExportResult } from '../../worker/protocol';
import { Section } from '../../controls/controls';
import { count } from '../../controls/numbers';
import { enumerated, say, sayCounted } from '../../language/say';

/** "No errors, no warnings." */
export const describeVerdict = ({ errors, warnings }: Validation): string =>
  errors === 0 && warnings === 0
    ? say('No errors, no warnings.')
    : enumerated([
        sayCounted(errors, '{count} error', '{count} errors'),
        sayCounted(warnings, '{count} warning', '{count} warnings'),
      ]);

export function Verdict({ exported }: { exported: ExportResult }) {
  const { validation } = exported;
  if (!validation)
    return (
      <Section title="Khronos validator">
        <p class="hint">{say('Not run: it reads only GLB and glTF.')}</p>
      </Section>
    );
  const { errors, messages } = validation;
  return (
    <Section title="Khronos validator">
      <p class={errors > 0 ? 'verdict bad' : 'verdict good'}>{describeVerdict(validation)}</p>
      <KnownMessages result={validation} input={exported.inputValidation} />
      {messages.length > 0 && (
        <ul class="hint">
          {messages.slice(0, 5).map((message) => (
            <li key={message}>{message}</li>
          ))}
        </ul>
      )}
    </Section>
  );
}

/** How many of the validator's findings it also reports for the input. */
function KnownMessages({ result, input }: { result: Validation; input: Validation | null }) {
  const { length: all } = result.messages;
  if (all === 0 || !input) return null;
  const known = knownMessages(result, input);
  return (
    <p class="hint">
      {known === all
        ? say('All of them were in your file.')
        : say('{known} of {all} were in your file.', { known: count(known), all: count(all) })}
    </p>
  );
}
