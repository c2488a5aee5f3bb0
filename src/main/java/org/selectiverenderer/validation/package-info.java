/**
 * The headless validator: says whether scenes are good X3D and whether their enrichment does what
 * its author means, with no display and no network.
 *
 * <pre>
 *  paths --SceneFinder--> files --FileChecker (in parallel)--> FileOutline + findings of the file
 *                                    | Inlines, each file once
 *                                    v
 *               SceneCheck: one scene with all it inlines --> findings of the scene
 *               RunCheck: all scenes                      --> findings of the run
 *                                    v
 *               severities of the settings --> Baseline --> Report --> report.*
 * </pre>
 *
 * <p>A file is parsed once, whoever inlines it. {@link org.selectiverenderer.validation.FileCheck}s
 * look at all its elements with their places and at the scene that the reader makes of them; then
 * the text and the coordinates are let go, and what is left, the {@link
 * org.selectiverenderer.validation.FileOutline}, is what {@link
 * org.selectiverenderer.validation.SceneCheck}s look at, so that memory is bounded by the largest
 * file. {@link org.selectiverenderer.validation.Findings} keeps none that the settings or a comment
 * in the file suppress; how many are listed is a matter of the report. Their order is that of their
 * places, whichever thread found them.
 *
 * <p>A rule is data in its group's package; a check finds what rules say and has no state. All that
 * can be said stands in the {@link org.selectiverenderer.validation.run.RuleCatalogue}, from which
 * {@code docs/rules.md} is written.
 *
 * <p>This package holds what rules, checks and reports speak of. Above it stand a package for each
 * group of rules, then {@code run}, which makes the checks, {@code settings}, what a project keeps
 * in files, and {@code report}.
 *
 * <p>In: files and folders, {@link org.selectiverenderer.validation.ValidationSettings}. Out:
 * {@link org.selectiverenderer.validation.Report}, which {@code validation.report} writes in one of
 * five formats: sorted, the same bytes on every machine. Uses {@code polygon.count}, {@code
 * geometry}, {@code x3d} and {@code base.problem}; the packages within also {@code schema} and
 * {@code base}. Loads no AWT and no GL.
 */
@NullMarked
package org.selectiverenderer.validation;

import org.jspecify.annotations.NullMarked;
