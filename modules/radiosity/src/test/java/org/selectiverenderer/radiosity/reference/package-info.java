/**
 * An independent proof of the light: a path tracer that shares nothing with the solution but the
 * ray caster ({@code radiosity.trace}) and the scene as it was read ({@code radiosity.scene}).
 *
 * <pre>
 * scene, viewpoint -> PrimaryHits: what each pixel shows, at 16 places of it
 *   -> PathTracer, Lights: paths from there -> ReferenceImage: sums, kept in a file
 *   -> LightingResultRenderer: the light that the lit result has at the same places
 *   -> Comparison: errors, and pictures side by side
 * </pre>
 *
 * <p>Unbiased: what is left is noise, which is measured by two halves of the samples. Light is
 * radiance in cd/m2, lengths are metres. {@code tools/compare-light} starts {@link
 * org.selectiverenderer.radiosity.reference.CompareLight}.
 */
@NullMarked
package org.selectiverenderer.radiosity.reference;

import org.jspecify.annotations.NullMarked;
