@NullMarked
package org.selectiverenderer.experiment.session;

import org.jspecify.annotations.NullMarked;
