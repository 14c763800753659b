/** Load states as X_ITE 15.0.1 numbers them: X3D gives an Inline no field that tells. */
const kNotStarted = 1006, kInProgress = 1007, kComplete = 1008;

/** 'absent', 'loading', 'live' or 'failed', from what an Inline is told to do and the number of its load state. */
export function loadPhase(isWanted, state) {
    if (!isWanted) return 'absent';
    if (state === kNotStarted || state === kInProgress) return 'loading';
    return state === kComplete ? 'live' : 'failed';
}
