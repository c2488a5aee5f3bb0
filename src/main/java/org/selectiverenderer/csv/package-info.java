/**
 * Tables of numbers as people exchange them: CSV whose columns are found by their names.
 *
 * <p>In: files. Out: numbers, or problems with their places ({@code file:line:column}). Uses {@code
 * x3d} for problems.
 */
@NullMarked
package org.selectiverenderer.csv;

import org.jspecify.annotations.NullMarked;
