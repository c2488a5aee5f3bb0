/**
 * Reads and writes JSON.
 *
 * <p>Hand-written files (studies, display profiles, validation settings) are read by {@link
 * org.selectiverenderer.formats.json.JsonSettingsReader} by these rules: UTF-8; comments ({@code
 * //} and {@code /* *}{@code /}) and a trailing comma are allowed; null means that the key is
 * absent; any such file may name its {@code $schema}. An unknown key, a repeated key, a wrong type,
 * a number out of range, a missing key, or invalid JSON is an error with line and column, and for
 * an unknown key the most similar known one is suggested. A file with an error is not used at all,
 * since the program would not do what its author meant: a display profile whose {@code
 * image_distance} is misspelt would show wrong depths. All errors of a file are reported at once.
 *
 * <p>{@link org.selectiverenderer.formats.json.JsonArrayEditor} edits an array in such a file,
 * {@link org.selectiverenderer.formats.json.JsonValueEditor} single values; both leave the rest
 * unchanged.
 *
 * <p>Files that programs exchange (journals, reports, descriptions, figures) are read by {@link
 * org.selectiverenderer.formats.json.JsonTree}, which ignores unknown keys, since newer versions
 * may add some, and written by {@link org.selectiverenderer.formats.json.JsonWriter} with LF line
 * ends and with numbers as in Java's {@code toString}.
 *
 * <p>Uses {@code base.problem} and {@code base.files}, and Jackson, of which only trees, generators
 * and the exception for invalid JSON are visible outside.
 */
@NullMarked
package org.selectiverenderer.formats.json;

import org.jspecify.annotations.NullMarked;
