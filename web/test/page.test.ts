import { describe, expect, it } from 'vitest';
import { firstFiles, parse, request } from '../src/page/description.js';
import { Progress } from '../src/page/progress.js';
import { words } from '../src/page/words.js';

const SCENE = { file: 'scene/a.x3dz', controller: 'SchemaController', condition: 'selective', seed: 7 };

describe('scene.json', () => {
  it('describes a scene; a title and sizes may be missing', () => {
    expect(parse('scene.json', SCENE)).toEqual({
      ...SCENE,
      title: 'scene/a.x3dz',
      files: {},
      later: [],
      normalMaps: true,
    });
  });

  it('tells which files the first picture may need', () => {
    const later = [{ object: 'Switch_Cup', choice: 0, inlines: ['Later'], files: ['models/a cup.x3dz'] }];
    const files = { 'scene/a.x3dz': 1, 'scene/models/a%20cup.x3dz': 2, 'scene/b.x3dz': 3 };
    expect(firstFiles(parse('scene.json', { ...SCENE, files, later }))).toEqual({ 'scene/a.x3dz': 1, 'scene/b.x3dz': 3 });
  });

  it.each([null, {}, [], 'text', { ...SCENE, file: 3 }, { ...SCENE, condition: 'low' }])('is refused: %j', (json) => {
    expect(() => parse('scene.json', json)).toThrow('scene.json does not describe a scene; export it anew');
  });
});

describe('the query of the address', () => {
  const exported = parse('scene.json', SCENE);

  it('names condition, seed, language and details', () => {
    expect(request('?condition=random&seed=-3&lang=el&details=1', exported, 'en')).toEqual({
      condition: 'random',
      seed: -3,
      language: 'el',
      details: true,
    });
  });

  it('that is not understood leaves what was exported', () => {
    expect(request('?condition=LOW&seed=1e9', exported, 'en-GB')).toEqual({
      condition: 'selective',
      seed: 7,
      language: 'en-GB',
      details: false,
    });
  });
});

describe('progress', () => {
  it('counts each file of the scene once, and no other', () => {
    const shown: number[] = [];
    const progress = new Progress({ 'a b.x3dz': 300, 'b.png': 100 }, 'http://host/site/index.html', (percent) => {
      shown.push(percent);
    });
    progress.arrived('http://host/site/a%20b.x3dz');
    progress.arrived('http://host/site/a%20b.x3dz');
    progress.arrived('http://host/other.png');
    progress.arrived('http://host/site/b.png');
    expect(shown).toEqual([0, 75, 100]);
  });
});

describe('words', () => {
  it('are Greek for Greek and English for all others', () => {
    expect(words('el-GR').fullScreen).toBe('Πλήρης οθόνη');
    expect(words('fr').fullScreen).toBe('Full screen');
  });
});
