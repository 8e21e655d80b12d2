/** The reasons why a simulation worker has ended. */

import { say } from '../language/say';

/** Rejects if the program of the worker cannot be loaded, or fails. */
export const failureOf = (worker: Worker): Promise<never> =>
  new Promise((_, reject) => {
    worker.addEventListener('error', ({ message }) =>
      reject(
        new Error(
          say('The simulation has stopped: {why}.', {
            why: message ?? say('its program could not be loaded'),
          }),
        ),
      ),
    );
  });
