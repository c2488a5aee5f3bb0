package org.selectiverenderer.runtime.render.window;

/**
 * How a monitor is driven.
 *
 * @param rate pictures per second; 0 where the system does not say
 * @param scale pixels per unit of the desktop, 1 for a desktop that is not enlarged
 */
public record MonitorMode(Monitor monitor, float rate, float scale) {}
