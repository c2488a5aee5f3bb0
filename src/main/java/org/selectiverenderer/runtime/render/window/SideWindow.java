package org.selectiverenderer.runtime.render.window;

import java.util.Optional;

/**
 * A window beside the main one, opened, fed and closed with it.
 *
 * @param options of which samples and buffers mean nothing here
 * @param input hears what is done in it; empty where it is one window with the main one to the
 *     user, who does the same in both
 */
public record SideWindow(WindowOptions options, SideSource source, Optional<InputListener> input) {}
