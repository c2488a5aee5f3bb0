package org.selectiverenderer.openxr;

import java.util.List;

/**
 * A frame that is due.
 *
 * @param display the runtime's time at which it will be seen
 * @param drawn whether anybody will see it; else it is ended without a picture
 * @param head in the space of the posture, at that time
 * @param eyes in the frame of the head, the left one first
 * @param floor whether heights are above the real floor, else above where the eyes were at first
 * @param lead nanoseconds from now to that time; negative when unknown
 */
public record XrFrame(
    long display,
    boolean drawn,
    SpacePose head,
    List<EyeSight> eyes,
    boolean floor,
    long lead,
    XrInput input) {}
