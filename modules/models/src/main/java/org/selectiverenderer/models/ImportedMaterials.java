package org.selectiverenderer.models;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.models.importer.ImportedModel;
import org.selectiverenderer.models.scene.DefNames;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.write.X3dNodeWriter;
import org.selectiverenderer.x3d.write.X3dWriter;

/** Writes the materials of an imported model as Appearances, each once. */
final class ImportedMaterials {
  private final X3dNodeWriter out;
  private final List<ParsedNode> appearances = new ArrayList<>();

  ImportedMaterials(
      ImportedModel model,
      ModelSource file,
      NodeCatalogue catalogue,
      X3dWriter out,
      DefNames names,
      ProblemCollector problems) {
    this.out = new X3dNodeWriter(out, X3dNodeWriter.Written.GIVEN);
    for (ImportedModel.ImportedMaterial material : model.materials()) {
      String def = names.unique("", "material" + appearances.size());
      appearances.add(
          new ImportedMaterialConverter(material, model.textures(), catalogue)
              .appearance(file.name(), def, problems));
    }
  }

  boolean isTextured(int material) {
    return TextureUsage.used(appearances.get(material));
  }

  /** Writes the Appearance of a material, and one that has been written as a USE. */
  void write(int material) {
    out.append(appearances.get(material), "appearance", (node, url) -> url);
  }
}
