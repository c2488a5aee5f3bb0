package org.selectiverenderer.scriptengine;

/** Marks Rhino's Context as one of the metered engine. The build lets it implement this. */
public interface Metered {}
