package org.selectiverenderer.render.window;

/**
 * How a window's frames are paced by the display.
 *
 * @param hertz refresh rate of the monitor in Hz; 0 where the system does not report it
 * @param synchronised whether the driver was asked to wait for the refresh, and did not refuse
 */
public record DisplayTiming(double hertz, boolean synchronised) {}
