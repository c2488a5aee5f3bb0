package org.selectiverenderer.app.window;

import java.awt.image.BufferedImage;
import java.util.List;

/**
 * The content of a {@link TrialWindow} for one trial.
 *
 * @param question text above the pictures
 * @param keys explanation of the keys, below the pictures
 * @param progress progress of the pilot, below the keys
 * @param pictures the pictures, side by side from the left
 * @param caption text below the middle picture; empty for none
 * @param choices labels of buttons below the pictures, answered by the keys 1, 2 ...; if empty, the
 *     first and the last picture are the choices, answered by the arrow keys
 * @param none label of the last button, answered by the key 0; empty for no such button
 */
public record TrialPage(
    String question,
    String keys,
    String progress,
    List<BufferedImage> pictures,
    String caption,
    List<String> choices,
    String none) {
  /** Number of the last button's choice. */
  public static final int NONE = -1;

  public TrialPage {
    pictures = List.copyOf(pictures);
    choices = List.copyOf(choices);
  }
}
