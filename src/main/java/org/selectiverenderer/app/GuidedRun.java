package org.selectiverenderer.app;

/**
 * A run in a {@link WindowChain}.
 *
 * @param listener hears what it has to say
 */
public record GuidedRun(RunSettings settings, RunListener listener, RunGuide guide) {}
