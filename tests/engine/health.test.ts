import { describe, expect, it } from 'vitest';
import { describeResiduals, describeSize, describeSolve } from '../../web/engine/body/health';
import { inFlags } from '../../web/cli/failure';
import { OPTIONS, wordNote } from '../../web/engine/settings/options';

describe('a note', () => {
  it('about a coarse solve names the remedy in the words of each host', () => {
    const [note] = describeSolve([], 8000);
    expect(inFlags(note)).toBe(
      'the modes come from a copy with 8,000 vertices (--exact solves the mesh itself)',
    );
    expect(wordNote(note, (setting) => OPTIONS[setting].label)).toContain('(Solve the mesh itself solves');
  });

  it('about the size appears if the size is implausible', () => {
    expect(describeSize(1)).toBeNull();
    expect(inFlags(describeSize(0.0005)!)).toBe(
      'the body is 0.50 mm across: set --unit if the file is not in metres',
    );
    expect(inFlags(describeSize(2e4)!)).toMatch(/^the body is 20 km across/);
  });

  it('about residuals appears if these are large', () => {
    expect(describeResiduals([{ residual: 1e-9 }])).toEqual([]);
    expect(describeSolve([{ residual: 1e-9 }, { residual: 1e-6 }], 0).map(inFlags)).toEqual([
      'the largest residual of the modes is 1.0e-6: with needle triangles their last digits are rounding errors',
    ]);
    expect(describeResiduals([0.9, 1e-5, 11].map((residual) => ({ residual })))).toEqual([
      'the largest residual of the modes is 1.1e+1: with needle triangles 2 modes consist of rounding errors',
    ]);
  });
});
