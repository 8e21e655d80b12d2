/** How to convert files of formats that cannot be read. */

interface OtherFormat {
  /** endings in lower case */
  endings: readonly string[];
  what: string;
  /** a sentence without its full stop */
  conversion: string;
}

const OTHERS: readonly OtherFormat[] = [
  {
    endings: ['blend', 'blend1'],
    what: 'a Blender file',
    conversion: 'in Blender choose File > Export > glTF 2.0 (.glb)',
  },
  {
    endings: ['fbx', 'dae', 'abc'],
    what: 'in a format that Limber cannot read',
    conversion: 'import it in Blender and choose File > Export > glTF 2.0 (.glb)',
  },
  {
    endings: ['usd', 'usda', 'usdc', 'usdz'],
    what: 'a USD file',
    conversion:
      'import it in Blender (File > Import > Universal Scene Description) and export it as glTF 2.0 (.glb)',
  },
  {
    endings: ['max', '3ds'],
    what: 'a 3ds Max file',
    conversion: 'in 3ds Max choose File > Export > Export and glTF (.glb)',
  },
  {
    endings: ['ma', 'mb'],
    what: 'a Maya scene',
    conversion: 'export it from Maya as OBJ, or as FBX and from there with Blender as GLB',
  },
  { endings: ['c4d'], what: 'a Cinema 4D file', conversion: 'in Cinema 4D choose File > Export > glTF' },
  {
    endings: ['skp'],
    what: 'a SketchUp file',
    conversion: 'in SketchUp choose File > Export > 3D Model as GLB',
  },
  { endings: ['zpr', 'ztl'], what: 'a ZBrush file', conversion: 'in ZBrush export the tool as OBJ' },
  {
    endings: ['hip', 'hipnc'],
    what: 'a Houdini file',
    conversion: 'in Houdini write it with a glTF ROP as GLB',
  },
  {
    endings: ['step', 'stp', 'iges', 'igs', '3dm', 'sldprt', 'f3d'],
    what: 'a CAD file, which has curved surfaces instead of a mesh',
    conversion: 'export it from the CAD program as STL or OBJ',
  },
  {
    endings: ['vrm', 'b3dm', 'vtk', 'vtu', 'x', 'x3d', 'wrl', '3mf'],
    what: 'in a format that Limber cannot read',
    conversion: 'convert it to GLB, OBJ, STL or PLY, in Blender or MeshLab',
  },
  {
    endings: ['rar', '7z', 'gz', 'tar'],
    what: 'an archive',
    conversion: 'unpack it, or pack what is inside as ZIP',
  },
  {
    endings: ['zip'],
    what: 'empty or damaged',
    conversion: 'pack the files again',
  },
];

/** How to convert a file of this name, as a sentence; null for unknown endings. */
export function describeConversion(name: string): string | null {
  const ending = name.toLowerCase().split('.').pop()!;
  const known = OTHERS.find(({ endings }) => endings.includes(ending));
  return known ? `${name} is ${known.what}: ${known.conversion}, then open that.` : null;
}
