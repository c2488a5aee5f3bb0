/**
 * The form of the selected Switch or ProximitySensor (thesis Figs 44, 46).
 *
 * <p>In: a session, pictures of versions. Out: edits of the document.
 */
@NullMarked
package org.selectiverenderer.enricher.form;

import org.jspecify.annotations.NullMarked;
