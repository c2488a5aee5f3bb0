@NullMarked
package org.selectiverenderer.experiment.questionnaire;

import org.jspecify.annotations.NullMarked;
