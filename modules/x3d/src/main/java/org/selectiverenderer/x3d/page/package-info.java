/**
 * The parser for scenes within pages of HTML and XHTML, such as those that X3DOM shows: the first
 * {@code x3d} element of a page is read, and everything around it is passed over.
 *
 * <p>{@code HtmlTokenizer} finds tags as browsers do, with values without quotes and attributes
 * without values, and {@code PageParser} calls the document with the names that X3D has for them,
 * since HTML does not tell upper from lower case. No library parses the page: the known ones build
 * a tree of all of it, which needs a hundred times the memory of a hostile page, and HTML would
 * move elements that it takes for its own.
 *
 * <p>In: text. Out: calls of a {@link org.selectiverenderer.x3d.source.ElementTreeBuilder}. Uses
 * {@code x3d.source}, {@code x3d.catalogue} and {@code x3d.field}.
 */
@NullMarked
package org.selectiverenderer.x3d.page;

import org.jspecify.annotations.NullMarked;
