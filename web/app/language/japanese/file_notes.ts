/** The notes of the file readers on what they have read, by the form of the English sentences. */

import type { MessageTable } from '../message_table';

export const FILE_NOTES: MessageTable = {
  // web/engine/document/gltf.ts, obj.ts, ply.ts, off.ts and stl.ts
  '{things}: the rest pose is used': '{things}: 静止時の姿勢を使用',
  'default weights of morph targets: measurements and motion use weights of 0':
    'モーフターゲットの初期の重み: 測定と動きでは重みを 0 とします',
  '{skins} and {animations}: the rest pose is used': '{skins}、{animations}: 静止時の姿勢を使用',
  'levels of detail: each keeps the same share of its faces, and the settings for when it is shown stay unchanged':
    'LOD: 各レベルの面を同じ割合で残し、切り替えの条件は変えません',
  '{count} texture': 'テクスチャ {count}',
  '{count} morph target': 'モーフターゲット {count}',
  '{count} morph targets': 'モーフターゲット {count}',
  '{count} camera': 'カメラ {count}',
  '{count} cameras': 'カメラ {count}',
  '{count} further scene': 'ほかのシーン {count}',
  '{count} further scenes': 'ほかのシーン {count}',
  '{count} mesh outside of the scene': 'シーン外のメッシュ {count}',
  '{count} meshes outside of the scene': 'シーン外のメッシュ {count}',
  '{count} primitive of points or lines': '点や線のプリミティブ {count}',
  '{count} primitives of points or lines': '点や線のプリミティブ {count}',
  'normals, which not all of its meshes have': '法線 (一部のメッシュにのみあるため)',
  'UVs, which not all of its meshes have': 'UV (一部のメッシュにのみあるため)',
  'vertex colours, which not all of its meshes have': '頂点カラー (一部のメッシュにのみあるため)',
  'vertex colours, which not all parts of a mesh have': '頂点カラー (メッシュの一部にのみあるため)',
  'opacity of vertex colours': '頂点カラーの不透明度',
  tangents: '接線',
  'further sets of vertex colours': '2 組目以降の頂点カラー',
  'further sets of UVs ({names})': '2 組目以降の UV ({names})',
  'metallic-roughness textures': 'メタリック・ラフネスのテクスチャ',
  'occlusion textures': 'オクルージョンのテクスチャ',
  '{name} (not in the folder of the input)': '{name} (入力のフォルダーにありません)',
  'attribute {name}': '属性 {name}',
  'extension {name}': '拡張 {name}',
  '{count} material': 'マテリアル {count}',
  '{count} materials': 'マテリアル {count}',
  '{count} material with {textures}': 'マテリアル {count} ({textures})',
  '{count} materials with {textures}': 'マテリアル {count} ({textures})',
  '{count} skin': 'スキン {count}',
  '{count} skins': 'スキン {count}',
  '{count} animation': 'アニメーション {count}',
  '{count} animations': 'アニメーション {count}',
  '{count} polygon with more than three corners cut into triangles': '多角形 {count} 個を三角形に分割',
  '{count} polygons with more than three corners cut into triangles': '多角形 {count} 個を三角形に分割',
  '{count} face with fewer than three corners': '頂点が 3 個未満の面 {count} 個',
  '{count} faces with fewer than three corners': '頂点が 3 個未満の面 {count} 個',
  '{count} line or point skipped': '線と点 {count} 個を読み飛ばし',
  '{count} lines and points skipped': '線と点 {count} 個を読み飛ばし',
  '{count} solids read as one body': 'ソリッド {count} 個を 1 つの物体として読み込み',
  '{count} unknown line skipped, the first is line {line}':
    '不明な行 {count} 行を読み飛ばし (最初は {line} 行目)',
  '{count} unknown lines skipped, the first is line {line}':
    '不明な行 {count} 行を読み飛ばし (最初は {line} 行目)',
  // web/engine/document/bodies.ts
  'mesh {name} has no triangles': 'メッシュ {name} に三角形がありません',
  'mesh {name} has no triangles ({reasons})': 'メッシュ {name} に三角形がありません ({reasons})',
  '{count} meshes ({names}) have no triangles': 'メッシュ {count} 個 ({names}) に三角形がありません',
  '{count} meshes ({names}) have no triangles ({reasons})':
    'メッシュ {count} 個 ({names}) に三角形がありません ({reasons})',
  'mesh {name} is left unchanged, because no node shows it':
    'メッシュ {name} はどのノードにも表示されないため、そのままにします',
  '{count} meshes ({names}) are left unchanged, because no node shows them':
    'メッシュ {count} 個 ({names}) はどのノードにも表示されないため、そのままにします',
  '{count} primitive of points skipped': '点のプリミティブ {count} 個を読み飛ばし',
  '{count} primitives of points skipped': '点のプリミティブ {count} 個を読み飛ばし',
  '{count} primitive of lines skipped': '線のプリミティブ {count} 個を読み飛ばし',
  '{count} primitives of lines skipped': '線のプリミティブ {count} 個を読み飛ばし',
  '{count} primitive without positions skipped': '座標のないプリミティブ {count} 個を読み飛ばし',
  '{count} primitives without positions skipped': '座標のないプリミティブ {count} 個を読み飛ばし',
  'its node scales it non-uniformly: frequencies use the mean scale':
    'ノードの拡大率が軸により異なるため、周波数には平均の拡大率を使用',
  // web/engine/document/checks
  '{count} texture has no image that can be read: the result is without it':
    'テクスチャ {count} 枚の画像を読み込めないため、結果には含まれません',
  '{count} textures have no image that can be read: the result is without them':
    'テクスチャ {count} 枚の画像を読み込めないため、結果には含まれません',
  '{count} texture ({names}) is missing or outside the folder: the result only refers to it':
    'テクスチャ {count} 枚 ({names}) が見つからないか、フォルダーの外にあります。結果には名前だけが残ります',
  '{count} textures ({names}) are missing or outside the folder: the result only refers to them':
    'テクスチャ {count} 枚 ({names}) が見つからないか、フォルダーの外にあります。結果には名前だけが残ります',
  '{names} and {count} more': '{names} ほか {count} 件',
  '{count} texture has a second image for older viewers, which is left out':
    'テクスチャ {count} 枚にある古いビューアー用の画像は除外されます',
  '{count} textures have a second image for older viewers, which is left out':
    'テクスチャ {count} 枚にある古いビューアー用の画像は除外されます',
  // web/engine/document/formats/obj/omissions.ts
  '{count} texture ({names}) left out, missing or outside the folder: put the pictures beside the model':
    'テクスチャ {count} 枚 ({names}) を除外: 見つからないか、フォルダーの外にあります。画像をモデルと同じ場所に置いてください',
  '{count} textures ({names}) left out, missing or outside the folder: put the pictures beside the model':
    'テクスチャ {count} 枚 ({names}) を除外: 見つからないか、フォルダーの外にあります。画像をモデルと同じ場所に置いてください',
  '{count} texture ({names}) left out, because glTF takes only PNG and JPEG: convert the pictures, and refer to the new ones in the material library':
    'テクスチャ {count} 枚 ({names}) を除外: glTF で使える PNG・JPEG ではありません。画像を変換し、マテリアルライブラリの名前も変えてください',
  '{count} textures ({names}) left out, because glTF takes only PNG and JPEG: convert the pictures, and refer to the new ones in the material library':
    'テクスチャ {count} 枚 ({names}) を除外: glTF で使える PNG・JPEG ではありません。画像を変換し、マテリアルライブラリの名前も変えてください',
  '{count} bump map ({names}) left out, because glTF uses normals instead of heights: bake a normal map and refer to it by norm':
    'バンプマップ {count} 枚 ({names}) を除外: glTF は高さではなく法線を使います。法線マップをベイクし、norm で指定してください',
  '{count} bump maps ({names}) left out, because glTF uses normals instead of heights: bake a normal map and refer to it by norm':
    'バンプマップ {count} 枚 ({names}) を除外: glTF は高さではなく法線を使います。法線マップをベイクし、norm で指定してください',
  '{count} map of opacity ({names}) left out, because glTF stores opacity in the colour picture: put it into the alpha channel of a PNG, and refer to that by map_Kd and map_d':
    '不透明度マップ {count} 枚 ({names}) を除外: glTF では不透明度は色の画像に入ります。PNG のアルファチャンネルに入れ、map_Kd と map_d で指定してください',
  '{count} maps of opacity ({names}) left out, because glTF stores opacity in the colour picture: put it into the alpha channel of a PNG, and refer to that by map_Kd and map_d':
    '不透明度マップ {count} 枚 ({names}) を除外: glTF では不透明度は色の画像に入ります。PNG のアルファチャンネルに入れ、map_Kd と map_d で指定してください',
  '{count} map of roughness or metalness ({names}) left out, because glTF stores both in one picture: put roughness into its green and metalness into its blue channel, and refer to it by map_Pr and map_Pm':
    'ラフネスまたはメタルネスのマップ {count} 枚 ({names}) を除外: glTF では 1 枚の画像にまとめます。緑にラフネス、青にメタルネスを入れ、map_Pr と map_Pm で指定してください',
  '{count} maps of roughness or metalness ({names}) left out, because glTF stores both in one picture: put roughness into its green and metalness into its blue channel, and refer to it by map_Pr and map_Pm':
    'ラフネスまたはメタルネスのマップ {count} 枚 ({names}) を除外: glTF では 1 枚の画像にまとめます。緑にラフネス、青にメタルネスを入れ、map_Pr と map_Pm で指定してください',
  '{count} material ({names}) plain, because no material library defines it':
    'マテリアル {count} 個 ({names}) は無地: どのマテリアルライブラリにもこの名前がありません',
  '{count} materials ({names}) plain, because no material library defines it':
    'マテリアル {count} 個 ({names}) は無地: どのマテリアルライブラリにもこの名前がありません',
  '{count} material library ({names}) left out, not text in UTF-8, or more than 8 MB: save it as UTF-8, or split it':
    'マテリアルライブラリ {count} 個 ({names}) を除外: UTF-8 のテキストでないか、8 MB を超えています。UTF-8 で保存するか、分割してください',
  '{count} material libraries ({names}) left out, not text in UTF-8, or more than 8 MB: save it as UTF-8, or split it':
    'マテリアルライブラリ {count} 個 ({names}) を除外: UTF-8 のテキストでないか、8 MB を超えています。UTF-8 で保存するか、分割してください',
  '{names} is missing: put it beside the OBJ to get the colours and textures of its materials':
    '{names} が見つかりません。マテリアルの色とテクスチャを使うには OBJ と同じ場所に置いてください',
  '{names} are missing: put them beside the OBJ to get the colours and textures of its materials':
    '{names} が見つかりません。マテリアルの色とテクスチャを使うには OBJ と同じ場所に置いてください',
  '{names} is missing or outside its folder: put it beside the OBJ to get the colours and textures of its materials':
    '{names} が見つからないか、フォルダーの外にあります。マテリアルの色とテクスチャを使うには OBJ と同じ場所に置いてください',
  '{names} are missing or outside its folder: put them beside the OBJ to get the colours and textures of its materials':
    '{names} が見つからないか、フォルダーの外にあります。マテリアルの色とテクスチャを使うには OBJ と同じ場所に置いてください',
};
