package org.selectiverenderer.models.gltf;

import org.selectiverenderer.models.scene.DefNames;
import org.selectiverenderer.x3d.write.X3dWriter;

/**
 * Holds what all writers of one translation share.
 *
 * @param file the model
 * @param out receives the scene
 * @param names the DEF names of the scene
 * @param problems receives what X3D has nothing for
 */
record GltfTranslation(GltfFile file, X3dWriter out, DefNames names, GltfProblems problems) {}
