/**
 * The commands for authors of scenes: {@code enrich}, {@code versions}, {@code simplify}, {@code
 * polygons}, {@code radiosity}, {@code validate}, {@code apartment}.
 *
 * <p>May use {@code command}, {@code cli.batch}, {@code cli.option}, {@code command.output} and the
 * packages that implement the commands.
 */
@NullMarked
package org.selectiverenderer.cli.author;

import org.jspecify.annotations.NullMarked;
