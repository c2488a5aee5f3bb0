/**
 * The headless validator: says whether scenes are good X3D and whether their enrichment does what
 * its author means, with no display and no network.
 *
 * <pre>
 *  paths --SceneFinder--> files --FileChecker (in parallel)--> FileOutline + findings of the file
 *                                    | Inlines, each file once
 *                                    v
 *                     SceneChecker: one scene with all it inlines --> findings of the scene
 *                                    v
 *        Filter (ignored rules, severities, comments in the file, baseline) --> Report --> report.*
 * </pre>
 *
 * <p>In: files and folders, {@link org.selectiverenderer.validation.ValidationSettings}. Out:
 * {@link org.selectiverenderer.validation.Report}, which {@code validation.report} writes in one of
 * five formats: sorted, the same bytes on every machine.
 *
 * <p>A file is parsed once, whoever inlines it. {@link org.selectiverenderer.validation.FileCheck}s
 * look at its document, where every attribute has its place; then the text and the coordinates are
 * let go, and what is left, the {@link org.selectiverenderer.validation.FileOutline}, is what
 * {@link org.selectiverenderer.validation.SceneCheck}s look at, so that memory is bounded by the
 * largest file. All that can be said stands in the {@link
 * org.selectiverenderer.validation.RuleCatalogue}; a package for each group of rules holds the
 * rules and their checks.
 *
 * <p>May use {@code x3d}, {@code schema} and {@code polygon.statistics}; loads no AWT and no GL.
 */
@NullMarked
package org.selectiverenderer.validation;

import org.jspecify.annotations.NullMarked;
