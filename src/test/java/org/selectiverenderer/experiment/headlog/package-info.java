@NullMarked
package org.selectiverenderer.experiment.headlog;

import org.jspecify.annotations.NullMarked;
