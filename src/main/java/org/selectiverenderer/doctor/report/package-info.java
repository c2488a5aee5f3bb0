/**
 * The report of the command {@code doctor}, for people and for programs.
 *
 * <p>In: {@link org.selectiverenderer.doctor.Diagnosis}. Out: lines of text, or JSON by {@code
 * doctor.schema.json}, which lies beside this package's classes.
 */
@NullMarked
package org.selectiverenderer.doctor.report;

import org.jspecify.annotations.NullMarked;
