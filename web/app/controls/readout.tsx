/** One number under the viewport. */

export function Readout({
  name,
  value,
  note,
  isBad,
}: {
  name: string;
  value: string;
  note: string;
  isBad?: boolean;
}) {
  return (
    <div class={isBad ? 'bad' : undefined}>
      <dt>{name}</dt>
      <dd>
        <strong>{value}</strong>
        <span class="muted">{note}</span>
      </dd>
    </div>
  );
}
