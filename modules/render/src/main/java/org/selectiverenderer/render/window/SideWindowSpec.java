package org.selectiverenderer.render.window;

import java.util.Optional;

/**
 * The specification of a window beside the main one, which is opened and closed with it.
 *
 * @param options the window's options; samples and quad buffers are ignored
 * @param input receives its input; empty where its input belongs to the main window's
 */
public record SideWindowSpec(
    WindowOptions options, SideWindowContent source, Optional<InputListener> input) {}
