import { describe, expect, it } from 'vitest';
import type { Report } from '../../web/engine/report/report';
import { reportAsCsv, reportAsMarkdown } from '../../web/engine/report/report_text';

const report = {
  schema: 'limber-report/1',
  command: 'optimize',
  options: { pins: 'low:6,"x"', lods: [0.5, 0.25], p: 2 },
  output: { faces: 100, genus: null, minAngle: 12.3456789 },
  modes: [
    { frequency: 1.5, name: 'bend' },
    { frequency: 2, name: 'a|b', component: 1 },
  ],
} as unknown as Report;

describe('a report as text', () => {
  it('has each value under its path in CSV, quoted if necessary', () => {
    const lines = reportAsCsv(report).split('\r\n');
    expect(lines[0]).toBe('key,value');
    expect(lines).toContain('options.pins,"low:6,""x"""');
    expect(lines).toContain('options.lods.1,0.25');
    expect(lines).toContain('output.genus,');
    expect(lines).toContain('modes.1.name,a|b');
  });

  it('has no cell that a spreadsheet would run', () => {
    const named = { ...report, input: { name: '=HYPERLINK("x")', minimum: -1.5 } } as unknown as Report;
    const lines = reportAsCsv(named).split('\r\n');
    expect(lines).toContain(`input.name,"'=HYPERLINK(""x"")"`);
    expect(lines).toContain('input.minimum,-1.5');
  });

  it('has a table for each section in Markdown, with lists as rows', () => {
    const text = reportAsMarkdown(report);
    expect(text).toContain('# Limber report\n\n| key | value |\n| --- | --- |\n| schema | limber-report/1 |');
    expect(text).toContain('## output\n\n| key | value |\n| --- | --- |\n| faces | 100 |');
    expect(text).toContain('| minAngle | 12.3457 |');
    expect(text).toContain('| frequency | name | component |\n| --- | --- | --- |\n| 1.5 | bend |  |');
    expect(text).toContain('a\\|b');
  });
});
