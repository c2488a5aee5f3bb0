/**
 * Points that fill squares and hemispheres evenly. In: integers. Out: numbers that are the same on
 * every machine and with any number of threads. Uses nothing.
 */
@NullMarked
package org.selectiverenderer.radiosity.sampling;

import org.jspecify.annotations.NullMarked;
