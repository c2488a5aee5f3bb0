/**
 * JSON, read and written in one place.
 *
 * <p>What a person writes (studies, display profiles, validation settings) is read by {@link
 * org.selectiverenderer.base.json.JsonSettings}, to one policy: UTF-8; comments ({@code //} and
 * {@code /* *}{@code /}) and a comma after the last value are allowed; null is as if the key were
 * left out; any such file may name its {@code $schema}. An unknown key, a key that is there twice,
 * a wrong type, a number out of its range, a missing key, a text that is no JSON: each is an error
 * at its line and column, and an unknown key is told with the nearest known one. A file with an
 * error is not used at all, since what was meant is not what would be done: a display whose {@code
 * image_distance} is misspelt shows depths that nobody chose. All errors of a file are told at
 * once.
 *
 * <p>{@link org.selectiverenderer.base.json.JsonListText} changes a list in such a file and leaves
 * the rest as its author wrote it.
 *
 * <p>What programs write for programs (journals, reports, descriptions, figures) is read by {@link
 * org.selectiverenderer.base.json.JsonTree}, which passes over what it does not know, as newer
 * versions may say more, and written by {@link org.selectiverenderer.base.json.JsonText}: lines end
 * with LF everywhere, numbers are as Java's {@code toString} has them.
 *
 * <p>Uses {@code base.problem} and {@code base.files}, and Jackson, of which only trees, generators
 * and the exception for what is no JSON are seen outside.
 */
@NullMarked
package org.selectiverenderer.base.json;

import org.jspecify.annotations.NullMarked;
