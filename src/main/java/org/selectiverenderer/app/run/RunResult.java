package org.selectiverenderer.app.run;

import java.util.Optional;
import org.selectiverenderer.app.figures.RunFigures;
import org.selectiverenderer.runtime.render.context.Screenshot;

/**
 * How a run ended.
 *
 * @param problems whether anything was wrong with the scene
 * @param screenshot the last frame, where it was asked for
 * @param operator the last picture of the operator's window, where there was one
 */
public record RunResult(
    RunFigures figures,
    boolean problems,
    Optional<Screenshot> screenshot,
    Optional<Screenshot> operator) {}
