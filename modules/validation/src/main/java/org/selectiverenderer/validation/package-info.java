/**
 * The headless validator: checks whether scenes are valid X3D and whether their enrichment does
 * what its author intends, without a display and without network access.
 *
 * <pre>
 *  paths --SceneFinder--> files --ValidationRun.FileChecker (in parallel)--> FileOutline + findings of the file
 *                                    | Inlines, each file once
 *                                    v
 *               SceneCheck: one scene with all it inlines --> findings of the scene
 *               CrossSceneCheck: all scenes                      --> findings of the run
 *                                    v
 *               severities of the settings --> Baseline --> Report --> report.*
 * </pre>
 *
 * <p>A file is parsed once, however many scenes inline it. {@link
 * org.selectiverenderer.validation.FileCheck}s check all its elements with their locations and the
 * scene that the reader builds from them; then the text and the coordinates are released, and what
 * is left, the {@link org.selectiverenderer.validation.FileOutline}, is the input of {@link
 * org.selectiverenderer.validation.SceneCheck}s, so that memory is bounded by the largest file.
 * {@link org.selectiverenderer.validation.FindingCollector} drops those that the settings or a
 * comment in the file suppress. The order of findings is that of their locations, independent of
 * threads.
 *
 * <p>A rule is data in its group's package; a check finds violations of rules and has no state. All
 * rules are in the {@link org.selectiverenderer.validation.run.RuleCatalogue}, from which {@code
 * docs/rules.md} is generated.
 *
 * <p>This package has the types that rules, checks and reports share. On it depend a package for
 * each group of rules, then {@code run}, which runs the checks, {@code settings}, which reads
 * settings and baselines, and {@code report}.
 *
 * <p>In: files and folders, {@link org.selectiverenderer.validation.ValidationSettings}. Out:
 * {@link org.selectiverenderer.validation.ValidationReport}, which {@code validation.report} writes
 * in one of five formats, sorted and with the same bytes on every machine. Uses {@code polygon},
 * {@code geometry}, {@code x3d} and {@code base.problem}; the packages within also {@code schema}
 * and {@code base}. Loads no AWT and no GL.
 */
@NullMarked
package org.selectiverenderer.validation;

import org.jspecify.annotations.NullMarked;
