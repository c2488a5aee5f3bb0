package org.selectiverenderer.render.window;

/**
 * The refresh rate and scale of a monitor.
 *
 * @param rate the refresh rate in Hz; 0 where the system does not report it
 * @param scale pixels per unit of the desktop, 1 for a desktop that is not enlarged
 */
public record MonitorMode(Monitor monitor, float rate, float scale) {}
