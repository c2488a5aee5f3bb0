package org.selectiverenderer.app.run;

import org.selectiverenderer.app.settings.RunSettings;

/**
 * A run in a {@link RunSequence}: its settings, listener and guide.
 *
 * @param listener receives the events of the run
 */
public record RunRequest(RunSettings settings, RunListener listener, RunController guide) {}
