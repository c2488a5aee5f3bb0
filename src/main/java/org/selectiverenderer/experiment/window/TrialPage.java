package org.selectiverenderer.experiment.window;

import java.awt.image.BufferedImage;
import java.util.List;

/**
 * What a {@link TrialWindow} shows for one trial.
 *
 * @param question above the pictures
 * @param keys what may be pressed, below them
 * @param progress how far it is, below that
 * @param pictures side by side, from the left
 * @param caption below the middle picture; empty for none
 * @param choices buttons below the pictures, answered by the keys 1, 2 ...; where there are none,
 *     the first and the last picture are the choices, answered by the arrow keys
 * @param none what the last button says, answered by the key 0; empty for no such button
 */
public record TrialPage(
    String question,
    String keys,
    String progress,
    List<BufferedImage> pictures,
    String caption,
    List<String> choices,
    String none) {
  /** The choice of the last button. */
  public static final int NONE = -1;

  public TrialPage {
    pictures = List.copyOf(pictures);
    choices = List.copyOf(choices);
  }
}
