import { expose, wrap } from 'comlink';
import { afterAll, expect, it } from 'vitest';
import { SettingError } from '../../web/engine/settings/options';
import { carrySettingErrors } from '../../web/app/worker/errors';

carrySettingErrors();
const { port1, port2 } = new MessageChannel();
afterAll(() => port1.close());

const api = {
  refuse: (): void => {
    throw new SettingError('modes', ['names mode 9, but ', { setting: 'modeCount' }, ' computes only 8.']);
  },
  fail: (): void => {
    throw new RangeError('too large');
  },
};
expose(api, port2);
const remote = wrap<typeof api>(port1);

it('the error for a refused setting arrives with the setting and the sentence', async () => {
  const error: unknown = await remote.refuse().catch((thrown: unknown) => thrown);
  expect(error).toBeInstanceOf(SettingError);
  expect(error).toMatchObject({
    setting: 'modes',
    sentence: ['names mode 9, but ', { setting: 'modeCount' }, ' computes only 8.'],
  });
});

it('other errors arrive unchanged', async () => {
  await expect(remote.fail()).rejects.toMatchObject({ name: 'RangeError', message: 'too large' });
});
