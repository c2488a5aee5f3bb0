package org.selectiverenderer.enricher.form;

import java.awt.Image;
import java.util.function.Consumer;
import org.selectiverenderer.document.enrichment.SwitchNode;

/** Makes pictures of versions in the background. */
@FunctionalInterface
public interface VersionImages {
  /**
   * A version as it looks.
   *
   * @param polygons that it has
   */
  record Look(Image image, long polygons) {}

  /** No pictures, where there is no OpenGL. */
  VersionImages NONE = (node, choice, taken, failed) -> () -> {};

  /**
   * Asks for a picture; the answer comes on the event dispatch thread.
   *
   * @return takes the request back
   */
  Runnable request(
      SwitchNode node, SwitchNode.ChoiceNode choice, Consumer<Look> taken, Consumer<String> failed);
}
