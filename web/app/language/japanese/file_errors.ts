/** Why files cannot be opened, by the form of the English sentences. */

import type { MessageTable } from '../message_table';

export const FILE_ERRORS: MessageTable = {
  // web/engine/document/open.ts
  'a GLB, glTF, OBJ, STL, PLY or OFF file': 'GLB、glTF、OBJ、STL、PLY、OFF',
  'There is no file: choose {formats}.': 'ファイルがありません。{formats} のファイルを選んでください。',
  'There are {count} models ({names}): open one at a time.':
    'モデルが {count} 個あります ({names})。1 個ずつ開いてください。',
  '{name} is empty: export it again.': '{name} は空です。もう一度書き出してください。',
  '{name} is not a mesh that can be read: open {formats}.':
    '{name} は読み込めるメッシュではありません。{formats} のファイルを開いてください。',
  'None of the {count} files is a mesh that can be read: open {formats}.':
    '{count} 個のファイルに読み込めるメッシュがありません。{formats} のファイルを開いてください。',
  '{name} has no mesh: export it with a triangle mesh.':
    '{name} にメッシュがありません。三角形のメッシュを書き出してください。',
  '{name} has no triangles ({notes}): export it with a triangle mesh.':
    '{name} に三角形がありません ({notes})。三角形のメッシュを書き出してください。',
  '{name} has no triangles: export a mesh with faces.':
    '{name} に三角形がありません。面のあるメッシュを書き出してください。',
  // web/engine/document/checks/other_formats.ts
  '{name} is {what}: {way}, then open that.': '{name} は{what}です。{way}、それを開いてください。',
  'a Blender file': ' Blender のファイル',
  'in a format that Limber cannot read': '読み込めない形式',
  'a USD file': ' USD のファイル',
  'a 3ds Max file': ' 3ds Max のファイル',
  'a Maya scene': ' Maya のシーン',
  'a Cinema 4D file': ' Cinema 4D のファイル',
  'a SketchUp file': ' SketchUp のファイル',
  'a ZBrush file': ' ZBrush のファイル',
  'a Houdini file': ' Houdini のファイル',
  'a CAD file, which has curved surfaces instead of a mesh': 'メッシュではなく曲面を持つ CAD のファイル',
  'an archive': '圧縮ファイル',
  'empty or damaged': '空であるか壊れているファイル',
  'in Blender choose File > Export > glTF 2.0 (.glb)':
    'Blender で「ファイル > エクスポート > glTF 2.0 (.glb)」を選び',
  'import it in Blender and choose File > Export > glTF 2.0 (.glb)':
    'Blender でインポートして「ファイル > エクスポート > glTF 2.0 (.glb)」を選び',
  'import it in Blender (File > Import > Universal Scene Description) and export it as glTF 2.0 (.glb)':
    'Blender でインポートし (ファイル > インポート > Universal Scene Description)、glTF 2.0 (.glb) で書き出し',
  'in 3ds Max choose File > Export > Export and glTF (.glb)':
    '3ds Max で「ファイル > 書き出し > 書き出し」から glTF (.glb) を選び',
  'export it from Maya as OBJ, or as FBX and from there with Blender as GLB':
    'Maya から OBJ で書き出すか、FBX で書き出して Blender で GLB に変換し',
  'in Cinema 4D choose File > Export > glTF': 'Cinema 4D で「ファイル > 書き出し > glTF」を選び',
  'in SketchUp choose File > Export > 3D Model as GLB':
    'SketchUp で「ファイル > エクスポート > 3D モデル」から GLB を選び',
  'in ZBrush export the tool as OBJ': 'ZBrush でツールを OBJ で書き出し',
  'in Houdini write it with a glTF ROP as GLB': 'Houdini の glTF ROP で GLB を書き出し',
  'export it from the CAD program as STL or OBJ': 'CAD から STL か OBJ で書き出し',
  'convert it to GLB, OBJ, STL or PLY, in Blender or MeshLab':
    'Blender か MeshLab で GLB、OBJ、STL、PLY のいずれかに変換し',
  'unpack it, or pack what is inside as ZIP': '展開するか、中身を ZIP にまとめ',
  'pack the files again': 'ファイルをもう一度まとめ',
  // web/engine/document/gltf.ts and checks
  '{name} is not glTF (it has no "asset"): check that it is a mesh file.':
    '{name} は glTF ではありません ("asset" がありません)。メッシュのファイルか確認してください。',
  '{name} is not glTF (its text is not JSON): check that it is a mesh file.':
    '{name} は glTF ではありません (JSON 形式ではありません)。メッシュのファイルか確認してください。',
  '{name} is not glTF (its text is not JSON, from line {line}, column {count}): check that it is a mesh file.':
    '{name} は glTF ではありません ({line} 行 {count} 文字目から JSON 形式ではありません)。メッシュのファイルか確認してください。',
  '{name} is glTF {version}: convert it to glTF 2.0.':
    '{name} は glTF {version} です。glTF 2.0 に変換してください。',
  '{name} is glTF 1.0: convert it to glTF 2.0, as gltf-pipeline does.':
    '{name} は glTF 1.0 です。gltf-pipeline などで glTF 2.0 に変換してください。',
  '{name} is not a usable GLB ({problem}): export it again.':
    '{name} は使える GLB ではありません ({problem})。もう一度書き出してください。',
  'it does not start with "glTF"': '先頭が "glTF" ではありません',
  'it is cut off': '途中で切れています',
  'its first chunk is not JSON': '最初のチャンクが JSON ではありません',
  '{name} is not a valid glTF file ({problem}): export it again.':
    '{name} は正しい glTF ではありません ({problem})。もう一度書き出してください。',
  '{name} is not a valid glTF file ({problem}): check it with the glTF validator.':
    '{name} は正しい glTF ではありません ({problem})。glTF validator で確認してください。',
  '{name} requires {extensions}, which cannot be read: export it without this extension.':
    '{name} には読み込めない {extensions} が必要です。これを使わずに書き出してください。',
  '{name} needs {files}, which is missing: open the whole folder, or put the missing files beside it.':
    '{name} に必要な {files} がありません。フォルダーごと開くか、同じ場所に置いてください。',
  '{name} needs {files}, which are missing: open the whole folder, or put the missing files beside it.':
    '{name} に必要な {files} がありません。フォルダーごと開くか、同じ場所に置いてください。',
  '{name} refers to {path}, which is outside its folder and is therefore not read: put the file beside it and refer to it without a path.':
    '{name} が参照する {path} はフォルダーの外にあるため読み込みません。同じ場所に置き、パスなしで参照してください。',
  '{name} has nodes more than {count} levels deep: flatten it and export it again.':
    '{name} のノードの階層が {count} を超えています。階層を減らして書き出し直してください。',
  // web/engine/document/obj.ts, ply.ts, off.ts, stl.ts and text_scanner.ts
  '{name} has no faces: export it as a mesh with faces.':
    '{name} に面がありません。面のあるメッシュとして書き出してください。',
  '{name} has no facets: export it as a mesh with faces.':
    '{name} に面がありません。面のあるメッシュとして書き出してください。',
  '{name} has {count} vertex but no faces: export it as a mesh with faces.':
    '{name} には頂点 {count} 個がありますが、面がありません。面のあるメッシュとして書き出してください。',
  '{name} has {count} vertices but no faces: export it as a mesh with faces.':
    '{name} には頂点 {count} 個がありますが、面がありません。面のあるメッシュとして書き出してください。',
  '{name} is not STL: check that it is a mesh file.':
    '{name} は STL ではありません。メッシュのファイルか確認してください。',
  '{name} is not OFF (it starts with "{start}"): check that it is a mesh file.':
    '{name} は OFF ではありません (先頭が "{start}")。メッシュのファイルか確認してください。',
  '{name} is binary OFF, which cannot be read: export it as text.':
    '{name} は読み込めないバイナリの OFF です。テキストで書き出してください。',
  '{name} is text in UTF-16 or UTF-32: save it as UTF-8.':
    '{name} は UTF-16 か UTF-32 のテキストです。UTF-8 で保存してください。',
  '{name} is cut off or not STL ({expected} bytes expected, {count} found): export it again.':
    '{name} は途中で切れているか、STL ではありません ({expected} バイトのはずが {count} バイト)。もう一度書き出してください。',
  '{name}, line {line}: a face names vertex {vertex}, but the file has {count}: export it again.':
    '{name} の {line} 行目: 面が頂点 {vertex} を参照していますが、頂点は {count} 個です。もう一度書き出してください。',
  '{name}, line {line}: "{text}" is not OBJ, and the file has no faces: check that it is a mesh file.':
    '{name} の {line} 行目: "{text}" は OBJ ではなく、面もありません。メッシュのファイルか確認してください。',
  'vertices have no {axis}: export it again': '頂点に {axis} がありません。もう一度書き出してください',
  '{name}, line {line}: {problem}.': '{name} の {line} 行目: {problem}。',
  '{name}, byte {at}: {problem}.': '{name} の {at} バイト目: {problem}。',
  'the file ends too early: export it again': 'ファイルが途中で終わっています。もう一度書き出してください',
  'a coordinate is too large for a 32-bit number': '座標が 32 ビットの数値に収まりません',
  'a face names vertex 0, but vertices are numbered from 1':
    '面が頂点 0 を参照していますが、頂点の番号は 1 から始まります',
  'a face names vertex {vertex}, but only {count} come before it':
    '面が頂点 {vertex} を参照していますが、それより前の頂点は {count} 個です',
  'the corner "{corner}" is not a vertex number': '角 "{corner}" は頂点の番号ではありません',
  '{what} is missing': '{what} がありません',
  '{what} is missing and the file seems cut off: export it again':
    '{what} がなく、ファイルが途中で切れているようです。もう一度書き出してください',
  '{what} is "{word}", not a number': '{what} が数値ではなく "{word}" です',
  // web/engine/document/zip
  '{name} has no file in it: pack the model with its files.':
    '{name} にファイルがありません。モデルと関連ファイルをまとめてください。',
  '{name} is damaged, encrypted or compressed by another method than deflate: pack it again.':
    '{name} は壊れているか、暗号化されているか、deflate 以外で圧縮されています。もう一度まとめてください。',
  '{name} has a file that leads out of its folder ({file}): pack it again without that file.':
    '{name} にフォルダーの外を指すファイル ({file}) があります。それを除いてまとめ直してください。',
  '{name} unpacks to more than 2 GB: split it into several files.':
    '{name} は展開すると 2 GB を超えます。複数のファイルに分けてください。',
  // web/engine/stages
  '{name} has {faces}, for which the core needs about {needed} of memory, but it may use only {limit}: {cure}.':
    '{name} は{faces}あり、約 {needed} のメモリが必要ですが、使えるのは {limit} です。{cure}。',
  'add ?memory=4G to the address, or reduce the mesh in parts':
    'アドレスに ?memory=4G を付けるか、メッシュを分けて削減してください',
  'Body "{name}" has no usable face, {count} with a repeated vertex: repair it and export it again.':
    '物体 "{name}" に使える面がありません (頂点が重複する面 {count} 個)。修復して書き出し直してください。',
};
