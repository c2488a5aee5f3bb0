/**
 * Tests of where native libraries are loaded from: each is used in a process whose folder of
 * temporary files holds what another user of the machine may have put there.
 */
@NullMarked
package org.selectiverenderer.natives;

import org.jspecify.annotations.NullMarked;
