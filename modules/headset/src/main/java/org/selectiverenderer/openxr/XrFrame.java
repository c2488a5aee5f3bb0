package org.selectiverenderer.openxr;

import java.util.List;

/**
 * A frame that is due.
 *
 * @param display predicted display time, by the runtime's clock in nanoseconds
 * @param drawn whether the frame is to be rendered; if not, it is ended without a picture
 * @param head predicted pose of the head in the space of the posture
 * @param eyes predicted views of the eyes in the frame of the head, the left one first
 * @param floor whether heights are above the real floor; if not, they are above the initial
 *     position of the eyes
 * @param lead nanoseconds from now to the display time; negative if unknown
 */
public record XrFrame(
    long display,
    boolean drawn,
    XrPose head,
    List<XrEyeView> eyes,
    boolean floor,
    long lead,
    XrInputState input) {}
