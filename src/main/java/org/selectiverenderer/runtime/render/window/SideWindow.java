package org.selectiverenderer.runtime.render.window;

/**
 * A window beside the main one, opened, fed and closed with it.
 *
 * @param options of which samples and buffers mean nothing here
 */
public record SideWindow(WindowOptions options, SideSource source) {}
