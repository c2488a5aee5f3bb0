package org.selectiverenderer.export;

import java.util.function.UnaryOperator;
import org.selectiverenderer.schema.Condition;
import org.selectiverenderer.x3d.write.SceneFormat;

/**
 * How a scene is exported.
 *
 * @param condition the condition that the Script begins with
 * @param seed the random seed of the condition {@code random}
 * @param format the encoding of the scene; files that it names keep theirs
 * @param names gives the files that the scene names their names
 * @param script whether a Script controls the scene; if not, filters, triggers and ROUTEs do, which
 *     only know the condition {@code selective}
 */
public record ExportSettings(
    Condition condition,
    int seed,
    SceneFormat format,
    UnaryOperator<String> names,
    boolean script) {}
