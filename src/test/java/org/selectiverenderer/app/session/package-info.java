/** Sessions with real windows. */
@NullMarked
package org.selectiverenderer.app.session;

import org.jspecify.annotations.NullMarked;
