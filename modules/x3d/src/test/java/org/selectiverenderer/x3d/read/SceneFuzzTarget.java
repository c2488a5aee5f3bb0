package org.selectiverenderer.x3d.read;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.XmlDocument;
import org.selectiverenderer.x3d.write.SceneFormat;

/** Scenes in all encodings, plain and compressed, read and written in each. */
public final class SceneFuzzTarget {
  private static final NodeCatalogue CATALOGUE = NodeCatalogue.load();

  private SceneFuzzTarget() {}

  /** Reads one input. */
  public static void fuzzerTestOneInput(byte[] input) {
    X3dReader reader = new X3dReader(CATALOGUE);
    XmlDocument document;
    try {
      document = reader.document("fuzz.x3d", new ByteArrayInputStream(input), input.length);
    } catch (IOException e) {
      return; // Refused, for instance as too large.
    }
    reader.scene(document, new ProblemCollector());
    for (SceneFormat format : SceneFormat.values()) {
      format.text(document, CATALOGUE, new ProblemCollector());
    }
  }
}
