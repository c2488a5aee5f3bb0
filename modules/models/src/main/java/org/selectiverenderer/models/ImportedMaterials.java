package org.selectiverenderer.models;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.models.importer.ImportedModel;
import org.selectiverenderer.models.scene.DefNames;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.write.X3dNodeWriter;
import org.selectiverenderer.x3d.write.X3dWriter;

/** Writes the materials of an imported model as Appearances, and their pictures, each once. */
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
    ImportedImages pictures = new ImportedImages(model.textures());
    Map<String, ParsedNode> images = new HashMap<>();
    for (ImportedModel.ImportedMaterial material : model.materials()) {
      String def = names.unique("", "material" + appearances.size());
      ParsedNode appearance =
          new ImportedMaterialConverter(material, pictures, catalogue)
              .appearance(file.name(), def, problems);
      share(appearance, images, names);
      appearances.add(appearance);
    }
  }

  /** Gives an Appearance the ImageTexture that another one with the same picture has. */
  private static void share(ParsedNode appearance, Map<String, ParsedNode> images, DefNames names) {
    NodeView image = appearance.node("texture");
    if (image == null) {
      return;
    }
    String[] urls = image.strings("url");
    ParsedNode shared = images.get(urls[0]);
    if (shared == null) {
      String def = names.unique("", "picture" + images.size());
      shared = new ParsedNode(image.type(), def, appearance.location());
      shared.put(image.type().indexOf("url"), urls);
      images.put(urls[0], shared);
    }
    appearance.put(appearance.type().indexOf("texture"), shared);
  }

  boolean isTextured(int material) {
    return TextureUsage.used(appearances.get(material));
  }

  /** Writes the Appearance of a material, and one that has been written as a USE. */
  void write(int material) {
    out.append(appearances.get(material), "appearance", (node, url) -> url);
  }
}
