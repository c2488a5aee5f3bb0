package org.selectiverenderer.app.run;

import org.selectiverenderer.app.settings.RunSettings;

/**
 * A run in a {@link WindowChain}: its settings, listener and guide.
 *
 * @param listener receives the events of the run
 */
public record GuidedRun(RunSettings settings, RunListener listener, RunGuide guide) {}
