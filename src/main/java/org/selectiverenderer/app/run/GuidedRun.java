package org.selectiverenderer.app.run;

import org.selectiverenderer.app.settings.RunSettings;

/**
 * A run in a {@link WindowChain}.
 *
 * @param listener hears what it has to say
 */
public record GuidedRun(RunSettings settings, RunListener listener, RunGuide guide) {}
