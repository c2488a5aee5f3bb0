package org.selectiverenderer.document.enrichment;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import org.selectiverenderer.document.Edit;
import org.selectiverenderer.document.SceneDocument;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;

/** A small scene open for editing. */
public final class EnrichmentScenes {
  public final SceneDocument document;
  public final DocumentEnrichment enrichment;

  private EnrichmentScenes(SceneDocument document) {
    this.document = document;
    this.enrichment = new DocumentEnrichment(document, NodeCatalogue.load());
  }

  /** A whole scene. */
  public static EnrichmentScenes of(String text) {
    try {
      return new EnrichmentScenes(
          SceneDocument.of("scene.x3d", text.getBytes(StandardCharsets.UTF_8)));
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  /** Nodes in the scene. */
  public static EnrichmentScenes with(String nodes) {
    return of("<X3D version='4.0'>\n<Scene>\n" + nodes + "</Scene>\n</X3D>\n");
  }

  /** The nodes as they are now. */
  public String nodes() {
    String text = document.text().toString();
    return text.substring(text.indexOf("<Scene>\n") + 8, text.lastIndexOf("</Scene>"));
  }

  public EnrichedSwitch switchNode(String name) {
    return enrichment.switchesByName().get(name);
  }

  public EnrichedSensor sensor(String name) {
    return enrichment.sensorsByName().get(name);
  }

  public EnrichmentEdits edits() {
    return new EnrichmentEdits(enrichment);
  }

  public void perform(Edit edit) {
    document.perform(edit);
  }
}
