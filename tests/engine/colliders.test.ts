import { expect, it } from 'vitest';
import { collisionSceneOf } from '../../web/engine/motion/colliders';

it('reads floors, balls and capsules', () => {
  expect(collisionSceneOf('')).toEqual({ ground: null, colliders: [] });
  expect(collisionSceneOf('ground:-0.5+ball:1,2,3,0.25+capsule:0,0,0,1,0,0,0.1')).toEqual({
    ground: -0.5,
    colliders: [
      { from: [1, 2, 3], to: [1, 2, 3], radius: 0.25 },
      { from: [0, 0, 0], to: [1, 0, 0], radius: 0.1 },
    ],
  });
});

it.each(['floor:1', 'ground', 'ground:1,2', 'ball:1,2,3', 'capsule:0,0,0,1,0,0,', 'ball:1,2,x,1'])(
  'refuses %s with the forms',
  (text) => {
    expect(() => collisionSceneOf(text)).toThrow(
      `“Can touch” has "${text}": give ground:HEIGHT, ball:x,y,z,R or capsule:x0,y0,z0,x1,y1,z1,R, joined by +.`,
    );
  },
);

it.each(['ball:1,2,3,0', 'capsule:0,0,0,1,0,0,-1'])('refuses %s with the range', (text) => {
  expect(() => collisionSceneOf(text)).toThrow(`“Can touch” has "${text}": give a radius above 0.`);
});

it('refuses an empty term', () => {
  expect(() => collisionSceneOf('ground:1+')).toThrow(
    '“Can touch” has a + that does not join two terms: remove it, or give ground:HEIGHT, ',
  );
});

it('uses the last of several floors', () => {
  expect(collisionSceneOf('ground:1+ball:0,0,0,1+ground:2')).toMatchObject({ ground: 2 });
});
