@NullMarked
package org.selectiverenderer.study.questionnaire;

import org.jspecify.annotations.NullMarked;
