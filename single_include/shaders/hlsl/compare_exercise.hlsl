// umbrage 0.1.0, MIT License: compare_exercise

#ifndef UMBRAGE_HAS_COMPARE_EXERCISE
#define UMBRAGE_HAS_COMPARE_EXERCISE
// umbrage_compare_exercise: 1.0 when current < stored + epsilon, else 0.0
float umbrage_compare_exercise(float current, float stored, float epsilon) {
    precise float limit = stored + epsilon;
    return current < limit ? 1.0 : 0.0;
}
#endif
