package org.selectiverenderer.authoring;

import java.io.IOException;
import org.selectiverenderer.authoring.enrichment.DocumentEnrichment;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;

/** Scenes as text that an author edits, in whatever charset. */
public final class SceneDocumentFuzzTarget {
  private static final NodeCatalogue CATALOGUE = NodeCatalogue.load();

  private SceneDocumentFuzzTarget() {}

  /** Reads one input. */
  public static void fuzzerTestOneInput(byte[] input) {
    try {
      SceneDocument document = SceneDocument.of("fuzz.x3d", input);
      new DocumentEnrichment(document, CATALOGUE).findings();
    } catch (IOException e) {
      // Not text.
    }
  }
}
