package org.selectiverenderer.app.run;

import java.util.Optional;
import org.selectiverenderer.app.metrics.RunMetrics;
import org.selectiverenderer.render.context.Screenshot;

/**
 * The result of a run.
 *
 * @param problems whether the scene had problems
 * @param screenshot the last frame, if it was asked for
 * @param operator the last picture of the operator's window, if there was one
 */
public record RunResult(
    RunMetrics figures,
    boolean problems,
    Optional<Screenshot> screenshot,
    Optional<Screenshot> operator) {}
