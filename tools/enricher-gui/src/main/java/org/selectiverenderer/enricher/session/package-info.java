/**
 * The open document and its selection, which all views of the enricher's window share.
 *
 * <p>In: selections and edits from the views. Out: the same to all others. For the event dispatch
 * thread only. Uses {@code enricher.task}, {@code authoring}, {@code x3d.catalogue} and {@code
 * x3d.source}; no widgets.
 */
@NullMarked
package org.selectiverenderer.enricher.session;

import org.jspecify.annotations.NullMarked;
